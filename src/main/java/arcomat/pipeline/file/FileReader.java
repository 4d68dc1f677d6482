package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/** Reads one file as UTF-8 text, or says why it cannot be read. */
public final class FileReader {
    /** Larger files are no models; reading them would only exhaust memory. */
    static final long LARGEST_BYTES = 256L << 20;

    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private FileReader() {}

    /** Either a file or a finding about it. */
    public record Read(Optional<SourceFile> file, Optional<Diagnostic> finding) {
        public static Read of(SourceFile file) {
            return new Read(Optional.of(file), Optional.empty());
        }

        static Read failed(Diagnostic finding) {
            return new Read(Optional.empty(), Optional.of(finding));
        }
    }

    /**
     * Reads a file that a command cannot do without.
     *
     * @param kind what it is to hold, in words
     * @param written the file as the user wrote it
     * @throws WrongUse where there is none, or it cannot be read
     */
    public static SourceFile required(String kind, String written, PathNames names)
            throws WrongUse {
        Path path = names.readable(written);
        if (!Files.isRegularFile(path)) {
            throw new WrongUse("there is no " + kind + " '" + written + "'");
        }
        return text(path, written);
    }

    /**
     * Reads a file that is there, and that a command cannot do without.
     *
     * @param shown how the user knows the file
     * @throws WrongUse where it cannot be read
     */
    public static SourceFile text(Path path, String shown) throws WrongUse {
        Read read = read(path, shown);
        return read.file()
                .orElseThrow(() -> new WrongUse(shown + ": " + read.finding().get().message()));
    }

    /**
     * Reads a text in UTF-8.
     *
     * @param shown how the user knows the file
     */
    public static Read read(Path path, String shown) {
        try {
            // A pipe or a device would never end.
            if (!Files.isRegularFile(path)) {
                return unreadable(shown, "is not a regular file");
            }
            long size = Files.size(path);
            if (size > LARGEST_BYTES) {
                return unreadable(
                        shown,
                        "has %s MiB; files above %s MiB are not read as models"
                                .formatted(size >> 20, LARGEST_BYTES >> 20));
            }
            return decode(Files.readAllBytes(path), shown);
        } catch (AccessDeniedException e) {
            return unreadable(shown, "cannot be read: permission denied");
        } catch (NoSuchFileException e) {
            return unreadable(shown, "does not exist");
        } catch (IOException e) {
            return unreadable(shown, "cannot be read: " + e.getMessage());
        }
    }

    /** A file that is left for later. */
    public static Read unread(String shown) {
        return unreadable(shown, "has not been read yet");
    }

    private static Read unreadable(String shown, String why) {
        return Read.failed(
                FileFindings.error(FileFindings.UNREADABLE, shown, "'" + shown + "' " + why));
    }

    static Read decode(byte[] bytes, String shown) {
        if (startsLikeUtf16(bytes)) {
            return Read.failed(
                    FileFindings.error(
                            FileFindings.NOT_UTF8,
                            shown,
                            "this file is UTF-16, not UTF-8; save it as UTF-8"));
        }
        int zero = indexOfZero(bytes);
        if (zero >= 0) {
            return Read.failed(
                    FileFindings.error(
                            FileFindings.BINARY,
                            shown,
                            "this file is binary: byte %s is zero; a model is plain text in UTF-8"
                                    .formatted(zero)));
        }
        try {
            CharBuffer text =
                    StandardCharsets.UTF_8
                            .newDecoder()
                            .onMalformedInput(CodingErrorAction.REPORT)
                            .decode(ByteBuffer.wrap(bytes));
            return Read.of(new SourceFile(shown, withoutByteOrderMark(text.toString())));
        } catch (CharacterCodingException e) {
            return Read.failed(notUtf8(bytes, shown));
        }
    }

    private static boolean startsLikeUtf16(byte[] bytes) {
        return bytes.length >= 2
                && ((bytes[0] == (byte) 0xFF && bytes[1] == (byte) 0xFE)
                        || (bytes[0] == (byte) 0xFE && bytes[1] == (byte) 0xFF));
    }

    private static int indexOfZero(byte[] bytes) {
        for (int i = 0; i < bytes.length; i++) {
            if (bytes[i] == 0) {
                return i;
            }
        }
        return -1;
    }

    /** The finding points at the place in the text where decoding fails. */
    private static Diagnostic notUtf8(byte[] bytes, String shown) {
        int offset = firstMalformed(bytes);
        String text =
                withoutByteOrderMark(
                        new String(bytes, StandardCharsets.UTF_8)); // with replacement characters
        int place =
                withoutByteOrderMark(new String(bytes, 0, offset, StandardCharsets.UTF_8)).length();
        return Diagnostic.error(
                FileFindings.NOT_UTF8,
                new SourceFile(shown, text).span(place, place + 1),
                String.format(
                        "byte %d (0x%02X) is not UTF-8; save the file as UTF-8",
                        offset, bytes[offset]));
    }

    private static int firstMalformed(byte[] bytes) {
        ByteBuffer in = ByteBuffer.wrap(bytes);
        CharBuffer out = CharBuffer.allocate(bytes.length + 1);
        CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(in, out, true);
        return result.isError() ? in.position() : 0;
    }

    private static String withoutByteOrderMark(String text) {
        return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? text.substring(1) : text;
    }
}
