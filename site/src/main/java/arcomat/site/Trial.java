package arcomat.site;

import arcomat.site.Shelf.Book;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.databind.ObjectMapper;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collection;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * A state of the live page, as its address says it.
 *
 * @param files to be worked on
 * @param needed lie around them
 * @param open which of the files is shown
 * @param view {@code see}, {@code run} or {@code prove}
 * @param component the one that is looked at
 */
@JsonPropertyOrder({"files", "needed", "open", "view", "component"})
public record Trial(List<Text> files, List<Text> needed, int open, String view, String component) {
    private static final ObjectMapper JSON = new ObjectMapper();

    @JsonPropertyOrder({"path", "text"})
    public record Text(String path, String text) {}

    static Trial of(Book shown, Collection<Book> written, Shelf shelf) {
        List<Book> files = new ArrayList<>(written);
        return new Trial(
                texts(files),
                texts(shelf.neededBy(files)),
                files.indexOf(shown),
                shown.path().endsWith(".mt") ? "prove" : "see",
                shown.path().endsWith(".arc") ? qualified(shown) : "");
    }

    private static String qualified(Book book) {
        return book.folder().isEmpty() ? book.name() : book.folder() + "." + book.name();
    }

    private static List<Text> texts(Collection<Book> books) {
        return books.stream().map(book -> new Text(book.path(), book.text())).toList();
    }

    /** As the live page unpacks it. */
    String packed() {
        try {
            byte[] plain = JSON.writeValueAsString(this).getBytes(StandardCharsets.UTF_8);
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
            try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater)) {
                out.write(plain);
            } finally {
                deflater.end();
            }
            return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes.toByteArray());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
