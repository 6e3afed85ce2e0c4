package steward.guest.project;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * Parser of a class file's constants and methods with code (The Java Virtual Machine Specification, chapter 4).
 *
 * @param constants by index: an Integer, a String for texts, the names of classes and {@link Member}s, or {@code null}
 * @param methods   those with code
 */
record ClassFile(Object[] constants, List<Method> methods) {

    private static final int MAGIC = 0xCAFEBABE;

    /** A field or method of a class, by its owner, name and descriptor. */
    record Member(String owner, String name, String descriptor) { }

    /** A method with its code. */
    record Method(Member member, boolean isStatic, byte[] code) { }

    /** @throws IOException if it is no class file, or ends too early */
    static ClassFile read(InputStream bytes) throws IOException {
        DataInputStream in = new DataInputStream(bytes);
        if (in.readInt() != MAGIC) {
            throw new IOException("found no class file");
        }
        in.readInt();                                          // its version
        Object[] constants = constants(in);
        in.readUnsignedShort();                                // its access
        String name = (String) constants[in.readUnsignedShort()];
        in.readUnsignedShort();                                // its superclass
        in.skipNBytes(2L * in.readUnsignedShort());            // its interfaces
        members(in, constants, name);
        return new ClassFile(constants, members(in, constants, name));
    }

    private static Object[] constants(DataInputStream in) throws IOException {
        Object[] constants = new Object[in.readUnsignedShort()];
        int[][] parts = new int[constants.length][];
        for (int k = 1; k < constants.length; k++) {
            int tag = in.readUnsignedByte();
            switch (tag) {
                case 1 -> constants[k] = in.readUTF();
                case 3 -> constants[k] = in.readInt();
                case 5, 6 -> {
                    in.readLong();
                    k++;                                       // it takes two places
                }
                case 7, 8 -> parts[k] = new int[] {tag, in.readUnsignedShort()};
                case 9, 10, 11, 12 -> parts[k] = new int[] {tag, in.readUnsignedShort(), in.readUnsignedShort()};
                case 15 -> in.skipNBytes(3);
                case 16, 19, 20 -> in.readUnsignedShort();
                case 4, 17, 18 -> in.readInt();
                default -> throw new IOException("found the constant " + tag);
            }
        }
        for (int k = 1; k < constants.length; k++) {
            if (parts[k] != null && parts[k][0] <= 8) {
                constants[k] = constants[parts[k][1]];
            }
        }
        for (int k = 1; k < constants.length; k++) {
            if (parts[k] != null && parts[k][0] >= 9 && parts[k][0] <= 11) {
                int[] type = parts[parts[k][2]];
                constants[k] = new Member((String) constants[parts[k][1]], (String) constants[type[1]],
                    (String) constants[type[2]]);
            }
        }
        return constants;
    }

    /** Reads fields or methods. */
    private static List<Method> members(DataInputStream in, Object[] constants, String owner) throws IOException {
        List<Method> methods = new ArrayList<>();
        for (int left = in.readUnsignedShort(); left > 0; left--) {
            boolean isStatic = (in.readUnsignedShort() & 8) != 0;
            Member member = new Member(owner, (String) constants[in.readUnsignedShort()],
                (String) constants[in.readUnsignedShort()]);
            for (int attributes = in.readUnsignedShort(); attributes > 0; attributes--) {
                boolean isCode = "Code".equals(constants[in.readUnsignedShort()]);
                int length = in.readInt();
                if (isCode) {
                    in.readInt();                              // its stack and locals
                    byte[] code = in.readNBytes(in.readInt());
                    in.skipNBytes(length - 8L - code.length);
                    methods.add(new Method(member, isStatic, code));
                } else {
                    in.skipNBytes(length);
                }
            }
        }
        return methods;
    }
}
