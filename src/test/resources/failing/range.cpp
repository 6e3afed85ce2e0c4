// says: what():  vector::_M_range_check: __n (which is 3) >= this->size() (which is 0)
#include <vector>
int main(){ std::vector<int> v; return v.at(3); }
