package arcomat.generate;

import arcomat.generate.template.ShippedTemplates;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * What code is made for: a description and templates. Shipped with the tool, or a user's own
 * folder; both are the same kind of folder. A target may stand on a shipped one and say only what
 * is different.
 *
 * @param name of a shipped target or path of a folder, as findings show it
 * @param files texts by file name; {@value #DESCRIPTION} is the description
 * @param base has the entries and templates that this target does not bring itself
 */
public record Target(String name, Map<String, String> files, Optional<Target> base) {
    public static final String DESCRIPTION = "target.properties";
    private static final String TEMPLATE = "template.";
    private static final String BASE = "base";

    public Target {
        files = Map.copyOf(files);
    }

    /** The entry by which templates ask for statements instead of the ways through them. */
    private static final String STATEMENTS = "statements";

    /** A target that stands on no other. */
    public Target(String name, Map<String, String> files) {
        this(name, files, Optional.empty());
    }

    /** A target that travels with the tool; empty where there is none of that name. */
    public static Optional<Target> shipped(String name) {
        if (!name.matches("[a-z][a-z0-9-]*")) {
            return Optional.empty();
        }
        return ShippedTemplates.text(name, DESCRIPTION)
                .map(text -> new Target(name, withTemplates(name, text)))
                .map(target -> target.on(target.baseName().flatMap(Target::shipped)));
    }

    /** The shipped target that this one wants to stand on. */
    public Optional<String> baseName() {
        return Optional.ofNullable(entries().get(BASE)).map(String::strip);
    }

    /** The same target, standing on another. */
    public Target on(Optional<Target> base) {
        return new Target(name, files, base);
    }

    private static Map<String, String> withTemplates(String name, String description) {
        Map<String, String> files = new LinkedHashMap<>();
        files.put(DESCRIPTION, description);
        Map<String, String> entries = entries(description);
        Stream<String> templates =
                entries.keySet().stream()
                        .filter(key -> key.startsWith(TEMPLATE))
                        .map(key -> key.substring(TEMPLATE.length()));
        String libraries = entries.getOrDefault("libraries", "");
        Stream.concat(templates, Stream.of(libraries.split("\\s+")))
                .filter(file -> !file.isEmpty())
                .forEach(
                        file ->
                                ShippedTemplates.text(name, file)
                                        .ifPresent(text -> files.put(file, text)));
        return files;
    }

    /** Whether its programs are compiled and packed for the brick. */
    public boolean isForBrick() {
        return entries().getOrDefault("programs", "").strip().equals("brick");
    }

    /** Where implementations of platform components are kept, under a model root. */
    public String platformFolder() {
        return "platform/" + name.substring(name.lastIndexOf('/') + 1);
    }

    /** Its own file of a name, or its base's. */
    Optional<SourceFile> file(String file) {
        String text = files.get(file);
        return text == null
                ? base.flatMap(b -> b.file(file))
                : Optional.of(new SourceFile(name + "/" + file, text));
    }

    /** The description that has an entry: its own, or its base's. */
    SourceFile descriptionWith(String key) {
        boolean own = entries(files.getOrDefault(DESCRIPTION, "")).containsKey(key);
        return own || base.isEmpty()
                ? new SourceFile(name + "/" + DESCRIPTION, files.getOrDefault(DESCRIPTION, ""))
                : base.get().descriptionWith(key);
    }

    /** Its own files and what the base has besides. */
    Map<String, String> allFiles() {
        Map<String, String> all = new TreeMap<>(base.map(Target::allFiles).orElse(Map.of()));
        all.putAll(files);
        return all;
    }

    /** The entries of the description, ordered by key; empty where there is no description. */
    Map<String, String> entries() {
        Map<String, String> all = new TreeMap<>(base.map(Target::entries).orElse(Map.of()));
        Map<String, String> own = entries(files.getOrDefault(DESCRIPTION, ""));
        all.putAll(own);
        if (!own.containsKey(STATEMENTS) && writesAutomata(all)) {
            all.remove(STATEMENTS);
        }
        return all;
    }

    /** Whether templates of its own write automata: they may know nothing of statements. */
    private boolean writesAutomata(Map<String, String> all) {
        List<String> libraries = List.of(all.getOrDefault("libraries", "").split("\\s+"));
        return files.keySet().stream().anyMatch(libraries::contains)
                || rules(all).stream()
                        .filter(rule -> Set.of("atomic", "event").contains(rule.subject()))
                        .anyMatch(rule -> files.containsKey(rule.template()));
    }

    private static Map<String, String> entries(String description) {
        Properties properties = new Properties();
        try {
            properties.load(new StringReader(description));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        Map<String, String> entries = new TreeMap<>();
        properties.stringPropertyNames().forEach(k -> entries.put(k, properties.getProperty(k)));
        return entries;
    }

    /**
     * What a template is filled in with, and where the result goes.
     *
     * @param subject as the description names it
     */
    record Rule(String template, String subject, String path) {
        /** {@code template.atomic.ftl = atomic | {folder}{name}.java}. */
        private static Rule of(String key, String line) {
            String[] parts = line.split("\\|", 2);
            String path = parts.length > 1 ? parts[1].strip() : "";
            return new Rule(key.substring(TEMPLATE.length()), parts[0].strip(), path);
        }
    }

    /** By the names of their templates. */
    List<Rule> rules() {
        return rules(entries());
    }

    private static List<Rule> rules(Map<String, String> entries) {
        return entries.entrySet().stream()
                .filter(entry -> entry.getKey().startsWith(TEMPLATE))
                .map(entry -> Rule.of(entry.getKey(), entry.getValue()))
                .toList();
    }
}
