// says: what():  std::bad_alloc
#include <vector>
int main(int n,char**){ std::vector<char> v(1ull<<(45+n)); return v[3]; }
