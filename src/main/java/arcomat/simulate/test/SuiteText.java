package arcomat.simulate.test;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.network.Network;
import arcomat.source.Signs;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes stream tests as the text of a suite in the package of their component. */
public final class SuiteText {
    /** Every break of a line; a browser's patterns have no word for them all. */
    private static final String BREAK = "\r\n|[\n\r\u000B\f\u0085\u2028\u2029]";

    /**
     * A test, or what is to become one.
     *
     * @param remarks lines to be written above it
     * @param inputs as in {@link StreamTest}
     * @param expected as in {@link StreamTest}
     */
    public record Entry(
            List<String> remarks,
            String name,
            List<Letter> inputs,
            Map<String, List<List<Value>>> expected) {
        public Entry(List<String> remarks, StreamTest test) {
            this(remarks, test.name(), test.inputs(), test.expected());
        }
    }

    private final Component component;
    private final Network network;
    private final StringBuilder text = new StringBuilder();

    private SuiteText(Component component, List<Value> arguments) {
        this.component = component;
        this.network = Network.of(component, arguments);
    }

    /**
     * @param suite its name, which is the name of its file
     * @param arguments of the component
     * @param remarks lines that tell where the suite comes from
     */
    public static String of(
            String suite,
            Component component,
            List<Value> arguments,
            List<String> remarks,
            List<Entry> entries) {
        SuiteText writer = new SuiteText(component, arguments);
        writer.head(suite, arguments, remarks);
        String separator = "";
        for (Entry entry : entries) {
            writer.text.append(separator);
            writer.entry(entry);
            separator = "\n";
        }
        writer.line("}");
        return writer.text.toString();
    }

    private void head(String suite, List<Value> arguments, List<String> remarks) {
        if (!component.packageName().isEmpty()) {
            line("package " + component.packageName() + ";");
            line("");
        }
        remarks.forEach(remark -> remark("", remark));
        line("testsuite " + suite + " for " + called(arguments) + " {");
    }

    private void entry(Entry entry) {
        entry.remarks().forEach(remark -> remark("  ", remark));
        line("  test " + entry.name() + " {");
        if (component.profile() == Component.Profile.TIME_SYNCHRONOUS) {
            slices(entry);
        } else {
            events(entry);
        }
        line("  }");
    }

    private void remark(String indent, String remark) {
        line(indent + "// " + remark.replaceAll(BREAK, " "));
    }

    private void line(String line) {
        text.append(Signs.withoutDirections(line)).append('\n');
    }

    /**
     * A configuration has the choice of its features in its name: behind the arguments, by name.
     */
    private String called(List<Value> arguments) {
        String name = component.name();
        int choice = name.indexOf('(');
        String written = list(arguments);
        return choice < 0 || written.isEmpty()
                ? name + written
                : name.substring(0, choice)
                        + written.substring(0, written.length() - 1)
                        + ", "
                        + name.substring(choice + 1);
    }

    private String list(List<Value> arguments) {
        List<String> written = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            written.add(text(arguments.get(i), component.parameters().get(i).type()));
        }
        return written.isEmpty() ? "" : "(" + String.join(", ", written) + ")";
    }

    /** A message as a suite has to write it: a literal of its type, a class by its full name. */
    private static String text(Value value, Type type) {
        if (value instanceof Value.ObjectValue object) {
            List<String> attributes = new ArrayList<>();
            for (int i = 0; i < object.attributes().size(); i++) {
                Type attribute = object.type().attributes().get(i).type();
                attributes.add(text(object.attributes().get(i), attribute));
            }
            return object.type().className() + "(" + String.join(", ", attributes) + ")";
        }
        return literal(value, type);
    }

    private static String literal(Value value, Type type) {
        if (value instanceof Value.IntegerValue number && number.value() != (int) number.value()) {
            return number + "L";
        }
        return value instanceof Value.RealValue real
                        && Double.isFinite(real.value())
                        && type instanceof Type.RealType kind
                        && kind.single()
                ? (float) real.value() + "f"
                : value.toString();
    }

    private void slices(Entry entry) {
        block(
                "input",
                network.inputs().stream()
                        .map(
                                input ->
                                        stream(
                                                input,
                                                entry.inputs().stream()
                                                        .map(each -> each.messages(input.name()))
                                                        .toList())));
        block(
                "expect",
                network.outputs().stream()
                        .filter(output -> entry.expected().containsKey(output.name()))
                        .map(
                                output ->
                                        stream(
                                                output,
                                                Objects.requireNonNull(
                                                        entry.expected().get(output.name())))));
    }

    private void block(String head, Stream<String> lines) {
        line("    " + head + " {");
        lines.forEach(each -> line("      " + each));
        line("    }");
    }

    private static String stream(Network.External external, List<List<Value>> messages) {
        List<String> slices = new ArrayList<>();
        for (List<Value> slice : messages) {
            slices.add(
                    slice.stream()
                                    .map(v -> text(v, external.port().type()) + ", ")
                                    .collect(Collectors.joining())
                            + "Tk");
        }
        return external.name() + ": <" + runLengths(slices) + ">;";
    }

    /** {@code a, Tk} three times is {@code 3*(a, Tk)}. */
    private static String runLengths(List<String> elements) {
        List<String> runs = new ArrayList<>();
        for (int start = 0; start < elements.size(); ) {
            String element = elements.get(start);
            int end = start;
            while (end < elements.size() && elements.get(end).equals(element)) {
                end++;
            }
            String repeated = element.endsWith(", Tk") ? "(" + element + ")" : element;
            runs.add(end - start == 1 ? element : (end - start) + "*" + repeated);
            start = end;
        }
        return String.join(", ", runs);
    }

    private void events(Entry entry) {
        block("events", entry.inputs().stream().flatMap(this::event));
        block(
                "expect",
                network.outputs().stream()
                        .map(
                                output ->
                                        all(
                                                output,
                                                entry.expected()
                                                        .getOrDefault(output.name(), List.of()))));
    }

    private Stream<String> event(Letter event) {
        return network.inputs().stream()
                .flatMap(
                        input ->
                                event.messages(input.name()).stream()
                                        .map(value -> text(value, input.port().type()))
                                        .map(message -> input.name() + ": " + message + ";"));
    }

    private static String all(Network.External output, List<List<Value>> messages) {
        List<String> texts =
                messages.stream()
                        .flatMap(List::stream)
                        .map(v -> text(v, output.port().type()))
                        .toList();
        return output.name() + ": <" + runLengths(texts) + ">;";
    }
}
