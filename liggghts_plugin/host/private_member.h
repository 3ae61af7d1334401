/* Reading a private member of a host's class. The arguments of an explicit template instantiation are exempt from
   access control [temp.spec], so a friend function defined by that instantiation may return the pointer to the
   private member: no header is edited, no layout is guessed. For each member

     struct Tag { typedef Type Class::*Member; friend Member memberOf(Tag); };
     template struct PrivateMember<Tag, &Class::member>;

   and then object->*memberOf(Tag()). */

#ifndef FRAZIL_PRIVATE_MEMBER_H
#define FRAZIL_PRIVATE_MEMBER_H

// no name: tag, instantiation and friend must be of one namespace, that of the source that includes this
namespace
{

template <class Tag, typename Tag::Member member> struct PrivateMember {
    friend typename Tag::Member memberOf(Tag) { return member; }
};

} // namespace

#endif
