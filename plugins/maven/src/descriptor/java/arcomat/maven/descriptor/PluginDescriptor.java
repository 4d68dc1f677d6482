package arcomat.maven.descriptor;

import arcomat.maven.descriptor.MojoClasses.Goal;
import arcomat.maven.descriptor.MojoClasses.Need;
import arcomat.maven.descriptor.MojoClasses.Setting;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;

/**
 * Writes {@code META-INF/maven/plugin.xml}, by which Maven finds goals and their settings: the
 * annotations of the classes in the form that Maven reads. Maven's own plugin that writes it runs
 * in a build of Maven.
 */
public final class PluginDescriptor {
    private final XMLStreamWriter xml;
    private final Descriptions descriptions;

    private PluginDescriptor(XMLStreamWriter xml, Descriptions descriptions) {
        this.xml = xml;
        this.descriptions = descriptions;
    }

    /** Folder of classes, file to write, group, artifact, version, description, sources. */
    public static void main(String[] arguments) throws IOException, XMLStreamException {
        MojoClasses classes = MojoClasses.in(Path.of(arguments[0]));
        Path file = Path.of(arguments[1]);
        Files.createDirectories(file.getParent());
        try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
            XMLStreamWriter xml = XMLOutputFactory.newInstance().createXMLStreamWriter(out);
            xml.writeStartDocument("UTF-8", "1.0");
            new PluginDescriptor(xml, Descriptions.in(Path.of(arguments[6])))
                    .plugin(classes, arguments[2], arguments[3], arguments[4], arguments[5]);
            xml.writeEndDocument();
        }
    }

    private void plugin(
            MojoClasses classes, String group, String artifact, String version, String description)
            throws XMLStreamException {
        within(
                "plugin",
                () -> {
                    text("name", artifact);
                    text("description", description);
                    text("groupId", group);
                    text("artifactId", artifact);
                    text("version", version);
                    text("goalPrefix", artifact.replace("-maven-plugin", ""));
                    text("isolatedRealm", "false");
                    text("inheritedByDefault", "true");
                    text("requiredJavaVersion", "17");
                    within("mojos", () -> classes.goals().forEach(this::goal));
                });
    }

    private void goal(Goal goal) {
        Map<String, String> said = goal.values();
        within(
                "mojo",
                () -> {
                    text("goal", said.get("name"));
                    text("description", descriptions.of(goal.type()));
                    if (said.containsKey("requiresDependencyResolution")) {
                        text(
                                "requiresDependencyResolution",
                                said.get("requiresDependencyResolution").toLowerCase(Locale.ROOT));
                    }
                    text("requiresProject", "true");
                    text("requiresDirectInvocation", "false");
                    text("requiresOnline", "false");
                    text("inheritedByDefault", "true");
                    text("phase", phase(said.getOrDefault("defaultPhase", "NONE")));
                    text("implementation", goal.type());
                    text("language", "java");
                    text("instantiationStrategy", "per-lookup");
                    text("executionStrategy", "once-per-session");
                    text("threadSafe", said.getOrDefault("threadSafe", "false"));
                    within("parameters", () -> goal.settings().forEach(this::parameter));
                    within("configuration", () -> goal.settings().forEach(this::configuration));
                    within("requirements", () -> goal.needs().forEach(this::requirement));
                });
    }

    private void requirement(Need need) {
        within(
                "requirement",
                () -> {
                    text("role", need.type());
                    text("field-name", need.field());
                });
    }

    private static String phase(String constant) {
        return constant.toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private void parameter(Setting setting) {
        within(
                "parameter",
                () -> {
                    text("name", setting.name());
                    text("type", setting.type());
                    text("required", setting.values().getOrDefault("required", "false"));
                    text("description", descriptions.of(setting.owner() + "#" + setting.name()));
                    text("editable", is(setting, "readonly") ? "false" : "true");
                });
    }

    /** Where its value comes from, if the build says nothing. */
    private void configuration(Setting setting) {
        String property = setting.values().get("property");
        String usual = setting.values().get("defaultValue");
        if (property == null && usual == null) {
            return;
        }
        within(
                setting.name(),
                () -> {
                    attribute("implementation", setting.type());
                    if (usual != null) {
                        attribute("default-value", usual);
                    }
                    if (property != null) {
                        characters("${" + property + "}");
                    }
                });
    }

    private static boolean is(Setting setting, String name) {
        return Boolean.parseBoolean(setting.values().getOrDefault(name, "false"));
    }

    private void text(String name, String text) {
        within(name, () -> characters(text));
    }

    private void within(String name, Runnable content) {
        write(() -> xml.writeStartElement(name));
        content.run();
        write(xml::writeEndElement);
    }

    private void attribute(String name, String value) {
        write(() -> xml.writeAttribute(name, value));
    }

    private void characters(String text) {
        write(() -> xml.writeCharacters(text));
    }

    private interface Piece {
        void write() throws XMLStreamException;
    }

    private static void write(Piece piece) {
        try {
            piece.write();
        } catch (XMLStreamException e) {
            throw new UncheckedIOException(new IOException(e));
        }
    }
}
