package arcomat.live.pack;

import org.tukaani.xz.LZMA2Options;
import org.tukaani.xz.LZMAOutputStream;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;

/**
 * The core as a part of a page, which is a text: packed, and written in letters. As browsers unpack
 * by themselves it would be half as large again; {@code unpack.js} unpacks this.
 */
final class PackedCore {
    /** Larger than the core, so that all of it is looked through for what is like the rest. */
    private static final int DICTIONARY = 8 << 20;

    private PackedCore() {}

    /** A script that gives it a name. */
    static String script(Path core) throws IOException {
        return "const packed = '" + Base64.getEncoder().encodeToString(packed(core)) + "';";
    }

    private static byte[] packed(Path core) throws IOException {
        byte[] bytes = Files.readAllBytes(core);
        LZMA2Options options = new LZMA2Options(LZMA2Options.PRESET_MAX);
        options.setDictSize(DICTIONARY);
        options.setNiceLen(LZMA2Options.NICE_LEN_MAX);
        options.setPb(0); // nothing in a module lies at even places
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (LZMAOutputStream out = new LZMAOutputStream(packed, options, bytes.length)) {
            out.write(bytes);
        }
        return packed.toByteArray();
    }
}
