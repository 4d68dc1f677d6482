package arcomat.generate;

import static java.util.stream.Collectors.joining;

import arcomat.generate.language.TargetLanguage;
import arcomat.generate.template.TemplateFailure;
import arcomat.model.Component;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Arrays;
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
        String message =
                "platform component %s needs an implementation for target %s: write %s/%s under the"
                        + " model root, beginning with\n%s";
        all.add(
                Diagnostic.error(
                        IMPLEMENTATION,
                        component.span(),
                        message.formatted(
                                component.qualifiedName(),
                                target.name(),
                                target.platformFolder(),
                                skeleton.path(),
                                skeleton.text())));
    }

    Diagnostic template(TemplateFailure failure) {
        String name = failure.template();
        SourceFile file = file(name);
        return Diagnostic.error(
                TEMPLATE,
                span(file, failure.line(), failure.column()),
                "template " + name + " cannot be filled in: " + failure.getMessage());
    }

    Diagnostic missing(TargetLanguage.MissingEntry failure) {
        return Diagnostic.error(
                DESCRIPTION,
                file(Target.DESCRIPTION).span(0, 0),
                "the description of target %s has no entry %s, which this model needs; add it to %s"
                        .formatted(target.name(), failure.getMessage(), Target.DESCRIPTION));
    }

    void kind(Target.Rule rule, OutputFiles.Kind... known) {
        String kinds = Arrays.stream(known).map(Object::toString).collect(joining(", "));
        String message = "template %s is for '%s', which is nothing to make files for; use one of ";
        all.add(
                Diagnostic.error(
                        DESCRIPTION,
                        entry(rule),
                        message.formatted(rule.template(), rule.subject()) + kinds));
    }

    void path(Target.Rule rule, String path, String why) {
        all.add(
                Diagnostic.error(
                        PATH,
                        entry(rule),
                        "template "
                                + rule.template()
                                + " would write '"
                                + path
                                + "', which "
                                + why));
    }

    private SourceFile file(String name) {
        return target.file(name).orElseGet(() -> new SourceFile(target.name() + "/" + name, ""));
    }

    /** The line of an entry in the description. */
    private Span entry(Target.Rule rule) {
        String key = "template." + rule.template();
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
