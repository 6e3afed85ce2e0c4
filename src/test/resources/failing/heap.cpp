// says: free(): double free detected
#include <cstdlib>
int main(){ char *volatile p = (char *) malloc(10); free(p); free(p); }
