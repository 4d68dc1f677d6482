package arcomat.generate;

import arcomat.generate.language.TemplateFailure;
import arcomat.model.Component;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/** Findings about the files of a target, at their places. */
final class TargetFindings {
    private static final String IMPLEMENTATION = "ARC0801";
    private static final String TEMPLATE = "ARC0802";
    private static final String DESCRIPTION = "ARC0803";
    private static final String PATH = "ARC0804";

    private final Target target;
    private final List<Diagnostic> all = new ArrayList<>();

    TargetFindings(Target target) {
        this.target = target;
    }

    List<Diagnostic> all() {
        return List.copyOf(all);
    }

    void addAll(List<Diagnostic> findings) {
        all.addAll(findings);
    }

    /** A platform component that somebody has to write a class for. */
    void implementation(Component component, GeneratedFile skeleton) {
        all.add(
                Diagnostic.error(
                        IMPLEMENTATION,
                        component.span(),
                        "platform component "
                                + component.qualifiedName()
                                + " needs an implementation for target "
                                + target.name()
                                + ": write "
                                + target.platformFolder()
                                + "/"
                                + skeleton.path()
                                + " under the model root, beginning with\n"
                                + skeleton.text()));
    }

    Diagnostic template(TemplateFailure failure) {
        SourceFile file = file(failure.template());
        return Diagnostic.error(
                TEMPLATE,
                span(file, failure.line(), failure.column()),
                "template " + failure.template() + " cannot be filled in: " + failure.getMessage());
    }

    Diagnostic missing(String entry) {
        SourceFile file = file(Target.DESCRIPTION);
        return Diagnostic.error(
                DESCRIPTION,
                file.span(0, 0),
                "the description of target "
                        + target.name()
                        + " has no entry "
                        + entry
                        + ", which this model needs; add it to "
                        + Target.DESCRIPTION);
    }

    void subject(String template, String subject, Iterable<String> known) {
        all.add(
                Diagnostic.error(
                        DESCRIPTION,
                        entry("template." + template),
                        "template "
                                + template
                                + " is for '"
                                + subject
                                + "', which is nothing to make files for; use one of "
                                + String.join(", ", known)));
    }

    void path(String template, String path, String why) {
        all.add(
                Diagnostic.error(
                        PATH,
                        entry("template." + template),
                        "template " + template + " would write '" + path + "', which " + why));
    }

    private SourceFile file(String name) {
        return target.file(name).orElseGet(() -> new SourceFile(target.name() + "/" + name, ""));
    }

    /** The line of an entry in the description. */
    private Span entry(String key) {
        SourceFile file = target.descriptionWith(key);
        int start = Math.max(0, file.text().indexOf(key));
        int end = file.text().indexOf('\n', start);
        return file.span(start, end < 0 ? file.text().length() : end);
    }

    private static Span span(SourceFile file, int line, int column) {
        int start = 0;
        for (int i = 1; i < line && i < file.lineCount(); i++) {
            start = file.text().indexOf('\n', start) + 1;
        }
        int end = file.text().indexOf('\n', start);
        int last = end < 0 ? file.text().length() : end;
        return file.span(Math.min(start + Math.max(0, column - 1), last), last);
    }
}
