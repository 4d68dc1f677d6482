package arcomat.generate.template;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;

/** The folders of templates that travel with the tool. */
public final class ShippedTemplates {
    private ShippedTemplates() {}

    /** The text of a file in one of them, if there is one. */
    public static Optional<String> text(String folder, String file) {
        String path = "/templates/" + folder + "/" + file;
        try (InputStream stream = ShippedTemplates.class.getResourceAsStream(path)) {
            return stream == null
                    ? Optional.empty()
                    : Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Fills in a template that is no part of a target: it lies in a folder without the description
     * that would make it one. Where it cannot be filled in, the tool is wrong.
     *
     * @param view what the template sees, its components by name
     */
    public static String render(String folder, String file, Record view) {
        String template = text(folder, file).orElseThrow();
        return new TemplateEngine(Map.of(file, template)).render(file, view);
    }
}
