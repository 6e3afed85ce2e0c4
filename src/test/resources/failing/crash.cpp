// says: what():  boom
#include <stdexcept>
#include <iostream>
int main(){ std::cerr<<"turn 1: no Error\n"; throw std::runtime_error("boom"); }
