#include "ParticleInbox.h"

#include <algorithm>

namespace frazil
{

ParticleView ParticleInbox::view() const
{
    ParticleView view;
    view.count = count();
    view.id = id_.data();
    view.position = position_.data();
    view.velocity = velocity_.data();
    view.angularVelocity = angularVelocity_.data();
    view.radius = radius_.data();
    view.exposure = exposure_.data();
    view.impulse = impulse_.data();
    view.motion = motion_.data();
    return view;
}

void ParticleInbox::fill(const std::vector<ParticleRecord>& records)
{
    resize(records.size());
    for (std::size_t k = 0; k < records.size(); ++k) {
        order_[k] = {records[k].id, std::int64_t(k)};
    }
    std::sort(order_.begin(), order_.end());
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const ParticleRecord& record = records[order_[i].second];
        id_[i] = record.id;
        position_[i] = record.position;
        velocity_[i] = record.velocity;
        angularVelocity_[i] = record.angularVelocity;
        impulse_[i] = record.impulse;
        radius_[i] = record.radius;
        exposure_[i] = record.exposure;
        motion_[i] = record.motion;
    }
}

void ParticleInbox::unsort(const std::vector<ParticleReply>& replies, std::vector<ParticleReply>& asReceived) const
{
    asReceived.resize(replies.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
        asReceived[order_[i].second] = replies[i];
    }
}

void ParticleInbox::resize(std::size_t count)
{
    order_.resize(count);
    id_.resize(count);
    position_.resize(count);
    velocity_.resize(count);
    angularVelocity_.resize(count);
    impulse_.resize(count);
    radius_.resize(count);
    exposure_.resize(count);
    motion_.resize(count);
}

} // namespace frazil
