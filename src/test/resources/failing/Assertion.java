// says: Exception in thread "main" java.lang.AssertionError: one is two
public class Assertion { public static void main(String[] a){ if (1 != 2) throw new AssertionError("one is two"); } }
