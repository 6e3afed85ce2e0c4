// says: Exception in thread "main" java.lang.OutOfMemoryError: Java heap space
public class Memory { public static void main(String[] a){ int[] x = new int[Integer.MAX_VALUE-5]; } }
