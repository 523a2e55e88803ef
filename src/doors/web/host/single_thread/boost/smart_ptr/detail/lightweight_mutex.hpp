// In place of Boost's header of this name, which needs threads: the module of a page has one.
#ifndef BOOST_SMART_PTR_DETAIL_LIGHTWEIGHT_MUTEX_HPP_INCLUDED
#define BOOST_SMART_PTR_DETAIL_LIGHTWEIGHT_MUTEX_HPP_INCLUDED

namespace boost {
namespace detail {

class lightweight_mutex {
 public:
    struct scoped_lock {
        explicit scoped_lock(lightweight_mutex&) {}
    };
};

}  // namespace detail
}  // namespace boost

#endif
