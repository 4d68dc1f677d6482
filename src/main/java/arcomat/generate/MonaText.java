package arcomat.generate;

import arcomat.generate.language.TemplateEngine;
import arcomat.generate.language.TemplateFailure;

import java.util.Map;

/**
 * Writes a formula for the program MONA. The template is no target for code: it lies in a folder
 * without the description that would make it one.
 */
public final class MonaText {
    private static final String TEMPLATE = "refinement.ftl";

    private MonaText() {}

    /**
     * The text of a formula.
     *
     * @param formula what the template sees, its components by name
     */
    public static String render(Record formula) {
        String template = Target.resource("mona", TEMPLATE).orElseThrow();
        try {
            return new TemplateEngine(Map.of(TEMPLATE, template)).render(TEMPLATE, formula);
        } catch (TemplateFailure e) {
            throw new IllegalStateException(
                    e.template() + ":" + e.line() + ":" + e.column() + ": " + e.getMessage(), e);
        }
    }
}
