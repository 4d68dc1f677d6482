import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** The prefix under which the shaded jar keeps third-party packages. */
final class Shading {
    static final String PATH = "org/gradle/internal/impldep/";
    static final String PACKAGE = PATH.replace('/', '.');

    static String undo(String text) {
        return without(without(text, PATH), PACKAGE);
    }

    /** A text that ends with the prefix talks about the prefix itself. */
    private static String without(String text, String prefix) {
        int at = text.indexOf(prefix);
        boolean names = at >= 0 && at + prefix.length() < text.length();
        return names ? text.replace(prefix, "") : text;
    }

    /**
     * Rewrites the text constants of a class file; nothing else in it depends on their length. Tags
     * are those of the Java virtual machine specification, section 4.4.
     */
    static byte[] undoInClass(byte[] classFile) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(classFile));
        ByteArrayOutputStream result = new ByteArrayOutputStream(classFile.length);
        DataOutputStream out = new DataOutputStream(result);
        out.writeLong(in.readLong()); // magic number and version
        int count = in.readUnsignedShort();
        out.writeShort(count);
        for (int i = 1; i < count; i++) {
            int tag = in.readUnsignedByte();
            out.writeByte(tag);
            switch (tag) {
                case 1 -> out.writeUTF(undo(in.readUTF()));
                case 7, 8, 16, 19, 20 -> out.write(in.readNBytes(2));
                case 15 -> out.write(in.readNBytes(3));
                case 3, 4, 9, 10, 11, 12, 17, 18 -> out.write(in.readNBytes(4));
                case 5, 6 -> {
                    out.write(in.readNBytes(8));
                    i++; // long and double take two places
                }
                default -> throw new IOException("unknown constant tag " + tag);
            }
        }
        in.transferTo(out);
        return result.toByteArray();
    }
}
