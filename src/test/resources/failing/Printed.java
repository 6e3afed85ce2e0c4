// says: java.lang.NumberFormatException: For input string: "dog"
public class Printed { public static void main(String[] a){ try { Integer.parseInt("dog"); } catch (Exception e) { e.printStackTrace(); System.exit(1);} } }
