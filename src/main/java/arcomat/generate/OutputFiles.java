package arcomat.generate;

import arcomat.generate.language.TypeName;
import arcomat.generate.template.TemplateEngine;
import arcomat.generate.text.LineMarks;
import arcomat.generate.view.ClassView;
import arcomat.generate.view.EnumView;
import arcomat.generate.view.HeadView;
import arcomat.generate.views.MessageTypes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Fills the templates of a target in and collects the files. */
final class OutputFiles {
    /** What files are made for; descriptions of targets name it in small letters. */
    enum Kind {
        ATOMIC,
        BORDER,
        CLASS,
        COMPOSITE,
        ENUM,
        EVENT,
        MONITOR,
        MONITORS,
        NETWORK,
        PLATFORM,
        PROGRAM,
        SECTION,
        SUBNETWORK;

        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        private static boolean isKnown(String word) {
            return Arrays.stream(values()).anyMatch(kind -> kind.toString().equals(word));
        }
    }

    private final List<Target.Rule> rules;
    private final TemplateEngine engine;
    private final TargetFindings findings;
    private final List<GeneratedFile> files = new ArrayList<>();
    private final Set<String> paths = new HashSet<>();
    private final Map<TypeName, LineMarks> marks = new HashMap<>();

    OutputFiles(Target target, TargetFindings findings) {
        this.rules = target.rules();
        this.engine = new TemplateEngine(target.allFiles());
        this.findings = findings;
        for (Target.Rule rule : rules) {
            if (!Kind.isKnown(rule.subject())) {
                findings.kind(rule, Kind.values());
            }
        }
    }

    List<GeneratedFile> all() {
        return files;
    }

    /** The enums and classes that messages are made of. */
    void write(MessageTypes types) {
        for (EnumView view : types.enums()) {
            write(Kind.ENUM, view.self(), view);
        }
        for (ClassView view : types.classes()) {
            write(Kind.CLASS, view.self(), view);
        }
    }

    /** Writes every file that the target makes for a component. */
    void write(Kind kind, HeadView head, Record view) {
        write(kind, head.self(), view);
    }

    /** Writes every file that the target makes for something. */
    void write(Kind kind, TypeName name, Record view) {
        for (Target.Rule rule : rules(kind)) {
            String path = path(rule, name);
            if (isFine(rule, path)) {
                LineMarks.Read read = LineMarks.read(engine.render(rule.template(), view));
                files.add(new GeneratedFile(path, read.text()));
                marks.putIfAbsent(name, read.marks());
            }
        }
    }

    private List<Target.Rule> rules(Kind kind) {
        return rules.stream().filter(rule -> rule.subject().equals(kind.toString())).toList();
    }

    private boolean isFine(Target.Rule rule, String path) {
        if (!isInside(path)) {
            findings.path(rule, path, "is not a place inside the output folder");
            return false;
        }
        if (!paths.add(path.toLowerCase(Locale.ROOT))) {
            findings.path(rule, path, "is written already; put {prefix} or {name} into its path");
            return false;
        }
        return true;
    }

    /** The lines of the first file that was written for something. */
    LineMarks marks(TypeName name) {
        return marks.getOrDefault(name, LineMarks.NONE);
    }

    /** Text that is no template's; once, however many ask for it. */
    void copy(String path, String text) {
        if (paths.add(path.toLowerCase(Locale.ROOT))) {
            files.add(new GeneratedFile(path, text));
        }
    }

    /** What the first template for a component gives, and where it would go. */
    Optional<GeneratedFile> draft(Kind kind, HeadView head, Record view) {
        return rules(kind).stream()
                .findFirst()
                .map(
                        rule ->
                                new GeneratedFile(
                                        path(rule, head.self()),
                                        engine.render(rule.template(), view)));
    }

    private static String path(Target.Rule rule, TypeName name) {
        return rule.path()
                .replace("{folder}", name.folder())
                .replace("{prefix}", name.prefix())
                .replace("{name}", name.name());
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
