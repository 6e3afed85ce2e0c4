// says: Exception in thread "main" java.lang.StackOverflowError
public class Stack { static int f(){return f()+1;} public static void main(String[] a){ f(); } }
