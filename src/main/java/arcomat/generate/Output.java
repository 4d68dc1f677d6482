package arcomat.generate;

import arcomat.generate.language.TemplateEngine;
import arcomat.generate.language.TemplateFailure;
import arcomat.generate.view.ClassView;
import arcomat.generate.view.EnumView;
import arcomat.generate.view.HeadView;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** Fills the templates of a target in and collects the files. */
final class Output {
    private static final Set<String> SUBJECTS =
            new TreeSet<>(
                    List.of(
                            "atomic",
                            "border",
                            "class",
                            "composite",
                            "enum",
                            "event",
                            "monitor",
                            "monitors",
                            "network",
                            "platform",
                            "program",
                            "section"));

    private final Map<String, Target.Rule> rules;
    private final TemplateEngine engine;
    private final TargetFindings findings;
    private final List<GeneratedFile> files = new ArrayList<>();
    private final Set<String> paths = new HashSet<>();

    Output(Target target, TargetFindings findings) {
        this.rules = target.rules();
        this.engine = new TemplateEngine(target.allFiles());
        this.findings = findings;
        for (Target.Rule rule : rules.values()) {
            if (!SUBJECTS.contains(rule.subject())) {
                findings.subject(rule.template(), rule.subject(), SUBJECTS);
            }
        }
    }

    List<GeneratedFile> files() {
        return files;
    }

    /** The enums and classes that messages are made of. */
    void write(MessageTypes types) throws TemplateFailure {
        for (EnumView view : types.enums()) {
            write("enum", view.folder(), view.prefix(), view.name(), view);
        }
        for (ClassView view : types.classes()) {
            write("class", view.folder(), view.prefix(), view.name(), view);
        }
    }

    /** Writes every file that the target makes for a component. */
    void write(String subject, HeadView head, Record view) throws TemplateFailure {
        write(subject, head.folder(), head.prefix(), head.name(), view);
    }

    /** Writes every file that the target makes for a subject. */
    void write(String subject, String folder, String prefix, String name, Record view)
            throws TemplateFailure {
        for (Target.Rule rule : rules.values()) {
            if (rule.subject().equals(subject)) {
                String path = path(rule, folder, prefix, name);
                if (isFine(rule.template(), path)) {
                    files.add(new GeneratedFile(path, engine.render(rule.template(), view)));
                }
            }
        }
    }

    private boolean isFine(String template, String path) {
        if (!isInside(path)) {
            findings.path(template, path, "is not a place inside the output folder");
            return false;
        }
        if (!paths.add(path.toLowerCase(Locale.ROOT))) {
            findings.path(
                    template, path, "is written already; put {prefix} or {name} into its path");
            return false;
        }
        return true;
    }

    /** Text that is no template's; once, however many ask for it. */
    void copy(String path, String text) {
        if (paths.add(path.toLowerCase(Locale.ROOT))) {
            files.add(new GeneratedFile(path, text));
        }
    }

    /** What the first template for a subject gives, and where it would go. */
    Optional<GeneratedFile> draft(String subject, HeadView head, Record view)
            throws TemplateFailure {
        for (Target.Rule rule : rules.values()) {
            if (rule.subject().equals(subject)) {
                String path = path(rule, head.folder(), head.prefix(), head.name());
                return Optional.of(new GeneratedFile(path, engine.render(rule.template(), view)));
            }
        }
        return Optional.empty();
    }

    private static String path(Target.Rule rule, String folder, String prefix, String name) {
        return rule.path()
                .replace("{folder}", folder)
                .replace("{prefix}", prefix)
                .replace("{name}", name);
    }

    /** Relative, made of plain names only; what begins with .arcomat is kept by the tool itself. */
    static boolean isInside(String path) {
        if (path.isEmpty() || path.indexOf('\\') >= 0 || path.indexOf(':') >= 0) {
            return false;
        }
        for (String segment : path.split("/", -1)) {
            if (segment.isEmpty()
                    || segment.equals(".")
                    || segment.equals("..")
                    || segment.startsWith(".arcomat")) {
                return false;
            }
        }
        return path.chars().noneMatch(Character::isISOControl);
    }
}
