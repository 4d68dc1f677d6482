package arcomat.generate;

import arcomat.generate.language.TemplateEngine;
import arcomat.generate.language.TemplateFailure;

import java.util.Map;

/**
 * A template of this tool that is no part of a target: it lies in a folder without the description
 * that would make it one. Where it cannot be filled in, the tool is wrong.
 */
final class OwnTemplate {
    private OwnTemplate() {}

    /**
     * Fills it in.
     *
     * @param view what the template sees, its components by name
     */
    static String render(String folder, String file, Record view) {
        String template = Target.resource(folder, file).orElseThrow();
        try {
            return new TemplateEngine(Map.of(file, template)).render(file, view);
        } catch (TemplateFailure e) {
            throw new IllegalStateException(
                    e.template() + ":" + e.line() + ":" + e.column() + ": " + e.getMessage(), e);
        }
    }
}
