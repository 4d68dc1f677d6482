package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.CodeLayout;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A generated monitor, compiled as Java 6 and shown runs. */
public final class CompiledMonitor {
    private final Component watched;
    private final CompiledModel compiled;
    private final CodeLayout.Place place;

    private CompiledMonitor(Component watched, CompiledModel compiled) {
        this.watched = watched;
        this.compiled = compiled;
        String name = watched.qualifiedName() + "Monitor";
        place = compiled.layout().components().get(name);
    }

    /** The monitor of all requirements of a component. */
    public static CompiledMonitor of(Component watched) {
        Target target = Target.shipped("jvm").orElseThrow();
        Generation generation = Monitors.generate(watched, watched.automata(), target);
        assertThat(generation.findings()).isEmpty();
        Map<String, String> sources = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            sources.put(file.path(), file.text());
        }
        Compilation compilation = MemoryCompiler.compile(sources, Map.of(), ClassFiles.RUNTIME);
        assertThat(compilation.problems()).isEmpty();
        ClassLoader loader =
                new ClassLoader(CompiledMonitor.class.getClassLoader()) {
                    @Override
                    protected Class<?> findClass(String name) throws ClassNotFoundException {
                        byte[] file = compilation.classes().get(name.replace('.', '/'));
                        if (file == null) {
                            throw new ClassNotFoundException(name);
                        }
                        return defineClass(name, file, 0, file.length);
                    }
                };
        return new CompiledMonitor(
                watched, new CompiledModel(watched, Choosing.FIRST, generation.layout(), loader));
    }

    /** What a monitor says about a run: what is violated, and why it does not know. */
    public record Word(String violation, String unknown) {}

    /** Shows a new monitor a run. */
    public Word watch(List<Value> arguments, Trace run) {
        GeneratedMonitor monitor = shown(arguments, run);
        return new Word(monitor.text("violation").strip(), monitor.text("unknown").strip());
    }

    /**
     * How many bytes a new monitor allocates while it is shown a run.
     *
     * @param warm how many slices or events it has seen before that
     */
    long allocated(List<Value> arguments, Trace run, int warm) {
        GeneratedMonitor monitor = shown(arguments, run);
        assertThat(monitor.text("violation") + monitor.text("unknown")).isEmpty();
        return monitor.allocatedAfter(warm);
    }

    private GeneratedMonitor shown(List<Value> arguments, Trace run) {
        JavaValues messages = new JavaValues(compiled);
        List<Object> constructor = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            constructor.add(messages.toJava(arguments.get(i), watched.parameters().get(i).type()));
        }
        Object made = compiled.instantiate(place.className(), constructor);
        GeneratedMonitor monitor = new GeneratedMonitor(made);
        if (watched.profile() == Component.Profile.EVENT_DRIVEN) {
            new ShownEvents(watched, monitor, slots(watched.inputs(), made, messages), messages)
                    .show(run);
        } else {
            showSlices(monitor, slots(watched.ports(), made, messages), run);
        }
        return monitor;
    }

    private List<PortSlot> slots(List<Port> ports, Object monitor, JavaValues messages) {
        return ports.stream()
                .map(port -> new PortSlot(port.name(), port, monitor, place, messages))
                .toList();
    }

    private static void showSlices(GeneratedMonitor monitor, List<PortSlot> slots, Trace run) {
        boolean kept = true;
        for (Trace.Step step : run.steps()) {
            if (kept) {
                write(slots, step.inputs(), step.outputs());
                kept = monitor.slice();
            }
        }
        if (kept && run.end().isPresent()) {
            Trace.End end = run.end().get();
            write(slots, end.inputs(), end.shown());
            monitor.error();
        }
    }

    private static void write(List<PortSlot> slots, Letter inputs, Letter outputs) {
        Map<String, List<Value>> both = new LinkedHashMap<>(inputs.messages());
        both.putAll(outputs.messages());
        slots.forEach(slot -> slot.write(new Letter(both)));
    }
}
