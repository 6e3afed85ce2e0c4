// says: terminate called after throwing an instance of 'int'
int main(){ throw 3; }
