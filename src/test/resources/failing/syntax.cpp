// says: error: expected primary-expression
int main(){ int x = ; return y; }
