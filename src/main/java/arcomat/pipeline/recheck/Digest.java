package arcomat.pipeline.recheck;

import arcomat.report.text.Sha256;

import java.util.HexFormat;

/** Short texts that differ where long ones do. */
final class Digest {
    private Digest() {}

    static String of(String text) {
        return HexFormat.of().formatHex(Sha256.of(text));
    }
}
