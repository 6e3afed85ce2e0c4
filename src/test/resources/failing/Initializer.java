// says: Caused by: java.lang.NumberFormatException: For input string: "dog"
public class Initializer { static int x = Integer.parseInt("dog"); public static void main(String[] a){ } }
