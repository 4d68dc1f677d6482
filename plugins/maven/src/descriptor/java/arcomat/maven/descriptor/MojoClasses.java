package arcomat.maven.descriptor;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AnnotationNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The goals in a folder of compiled classes. Annotations of Maven do not stay until classes are
 * loaded, so they are read where they are.
 */
final class MojoClasses {
    private static final String ANNOTATIONS = "Lorg/apache/maven/plugins/annotations/";

    private final Map<String, ClassNode> classes;

    private MojoClasses(Map<String, ClassNode> classes) {
        this.classes = classes;
    }

    /**
     * A goal.
     *
     * @param values of its annotation, as far as it says them
     * @param needs what Maven gives it
     */
    record Goal(
            String type, Map<String, String> values, List<Setting> settings, List<Need> needs) {}

    /** A part of Maven that a goal has in a field. */
    record Need(String field, String type) {}

    /**
     * What a goal is told by a build.
     *
     * @param owner the class that has the field
     * @param values of its annotation, as far as it says them
     */
    record Setting(String owner, String name, String type, Map<String, String> values) {}

    static MojoClasses in(Path folder) throws IOException {
        Map<String, ClassNode> classes = new HashMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(each -> each.toString().endsWith(".class")).toList()) {
                ClassNode node = new ClassNode();
                new ClassReader(Files.readAllBytes(file)).accept(node, ClassReader.SKIP_CODE);
                classes.put(node.name, node);
            }
        }
        return new MojoClasses(classes);
    }

    /** By their names. */
    List<Goal> goals() {
        List<Goal> goals = new ArrayList<>();
        for (ClassNode each : classes.values()) {
            annotation(each.invisibleAnnotations, "Mojo")
                    .ifPresent(
                            values ->
                                    goals.add(
                                            new Goal(
                                                    dotted(each),
                                                    values,
                                                    settings(each),
                                                    needs(each))));
        }
        goals.sort(Comparator.comparing(goal -> goal.values().get("name")));
        return goals;
    }

    private static String dotted(ClassNode type) {
        return type.name.replace('/', '.');
    }

    private static List<Need> needs(ClassNode goal) {
        List<Need> needs = new ArrayList<>();
        for (FieldNode field : goal.fields) {
            annotation(field.visibleAnnotations, "Component")
                    .or(() -> annotation(field.invisibleAnnotations, "Component"))
                    .ifPresent(values -> needs.add(new Need(field.name, className(field))));
        }
        return needs;
    }

    private static String className(FieldNode field) {
        return Type.getType(field.desc).getClassName();
    }

    /** Its own, and what it has from above. */
    private List<Setting> settings(ClassNode goal) {
        List<Setting> settings = new ArrayList<>();
        for (ClassNode each = goal; each != null; each = classes.get(each.superName)) {
            ClassNode at = each;
            for (FieldNode field : at.fields) {
                annotation(field.invisibleAnnotations, "Parameter")
                        .ifPresent(
                                values ->
                                        settings.add(
                                                new Setting(
                                                        dotted(at),
                                                        field.name,
                                                        className(field),
                                                        values)));
            }
        }
        settings.sort(Comparator.comparing(Setting::name));
        return settings;
    }

    private static Optional<Map<String, String>> annotation(
            List<AnnotationNode> annotations, String name) {
        return Stream.ofNullable(annotations)
                .flatMap(List::stream)
                .filter(each -> each.desc.equals(ANNOTATIONS + name + ";"))
                .findFirst()
                .map(MojoClasses::values);
    }

    /** The constant of an enum by its name. */
    private static Map<String, String> values(AnnotationNode annotation) {
        Map<String, String> values = new HashMap<>();
        List<Object> all = annotation.values == null ? List.of() : annotation.values;
        for (int i = 0; i < all.size(); i += 2) {
            Object value = all.get(i + 1);
            values.put(
                    (String) all.get(i),
                    value instanceof String[] constant ? constant[1] : value.toString());
        }
        return values;
    }
}
