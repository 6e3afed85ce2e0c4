// says: gave up
public class OwnWords { public static void main(String[] a){ System.err.println("no Error\n0 Exceptions\ngave up"); System.exit(1); } }
