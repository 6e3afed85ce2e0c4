// says: Caused by: java.lang.NumberFormatException: For input string: "dog"
public class Cause { public static void main(String[] a){ try { Integer.parseInt("dog"); } catch (Exception e) { throw new RuntimeException("cannot read", e);} } }
