// says: Exception in thread "main" java.lang.IllegalStateException: boom
public class Crash { static void d(int n){ if(n==0) throw new IllegalStateException("boom"); d(n-1);} public static void main(String[] a){ d(12);} }
