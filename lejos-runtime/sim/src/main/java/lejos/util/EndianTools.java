package lejos.util;

/** Numbers in arrays of bytes, with the highest byte first (BE) or last (LE). */
public class EndianTools {
    private static final long INT = 0xffffffffL;

    public static long decodeLongBE(byte[] b, int off) {
        return (long) decodeIntBE(b, off) << Integer.SIZE | decodeUIntBE(b, off + Integer.BYTES);
    }

    public static long decodeLongLE(byte[] b, int off) {
        return (long) decodeIntLE(b, off + Integer.BYTES) << Integer.SIZE | decodeUIntLE(b, off);
    }

    public static int decodeIntBE(byte[] b, int off) {
        return decodeUShortBE(b, off) << Short.SIZE | decodeUShortBE(b, off + Short.BYTES);
    }

    public static int decodeIntLE(byte[] b, int off) {
        return decodeUShortLE(b, off + Short.BYTES) << Short.SIZE | decodeUShortLE(b, off);
    }

    public static long decodeUIntBE(byte[] b, int off) {
        return decodeIntBE(b, off) & INT;
    }

    public static long decodeUIntLE(byte[] b, int off) {
        return decodeIntLE(b, off) & INT;
    }

    public static short decodeShortBE(byte[] b, int off) {
        return (short) decodeUShortBE(b, off);
    }

    public static short decodeShortLE(byte[] b, int off) {
        return (short) decodeUShortLE(b, off);
    }

    public static int decodeUShortBE(byte[] b, int off) {
        return (b[off] & 0xff) << Byte.SIZE | b[off + 1] & 0xff;
    }

    public static int decodeUShortLE(byte[] b, int off) {
        return (b[off + 1] & 0xff) << Byte.SIZE | b[off] & 0xff;
    }

    public static void encodeLongBE(long v, byte[] b, int off) {
        encodeIntBE((int) (v >> Integer.SIZE), b, off);
        encodeIntBE((int) v, b, off + Integer.BYTES);
    }

    public static void encodeLongLE(long v, byte[] b, int off) {
        encodeIntLE((int) v, b, off);
        encodeIntLE((int) (v >> Integer.SIZE), b, off + Integer.BYTES);
    }

    public static void encodeIntBE(int v, byte[] b, int off) {
        encodeShortBE(v >> Short.SIZE, b, off);
        encodeShortBE(v, b, off + Short.BYTES);
    }

    public static void encodeIntLE(int v, byte[] b, int off) {
        encodeShortLE(v, b, off);
        encodeShortLE(v >> Short.SIZE, b, off + Short.BYTES);
    }

    public static void encodeShortBE(int v, byte[] b, int off) {
        b[off] = (byte) (v >> Byte.SIZE);
        b[off + 1] = (byte) v;
    }

    public static void encodeShortLE(int v, byte[] b, int off) {
        b[off] = (byte) v;
        b[off + 1] = (byte) (v >> Byte.SIZE);
    }
}
