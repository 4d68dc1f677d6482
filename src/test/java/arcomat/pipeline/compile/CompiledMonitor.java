package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.Choosing;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Layout;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A generated monitor, compiled as Java 6 and fed with letters. */
final class CompiledMonitor {
    private final Component watched;
    private final CompiledModel compiled;
    private final Layout.Place place;

    private CompiledMonitor(Component watched, CompiledModel compiled) {
        this.watched = watched;
        this.compiled = compiled;
        String name = watched.qualifiedName() + "Monitor";
        place = compiled.layout().components().get(name);
    }

    /** The monitor of all requirements of a component. */
    static CompiledMonitor of(Component watched) {
        Target target = Target.shipped("jvm").orElseThrow();
        Generation generation = Monitors.generate(watched, watched.automata(), target);
        assertThat(generation.findings()).isEmpty();
        Map<String, String> sources = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            sources.put(file.path(), file.text());
        }
        Compilation compilation = MemoryCompiler.compile(sources, Map.of(), new RuntimeClasses());
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

    /**
     * Shows the monitor a run.
     *
     * @param slices inputs and outputs together
     * @return what the monitor says, slice by slice, until it says something
     */
    List<String> watch(List<Value> arguments, List<Letter> slices) {
        Messages messages = new Messages(compiled);
        List<Object> constructor = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            constructor.add(messages.toJava(arguments.get(i), watched.parameters().get(i).type()));
        }
        Object monitor = compiled.instantiate(place.className(), constructor);
        List<PortSlot> slots =
                watched.ports().stream()
                        .map(port -> new PortSlot(port.name(), port, monitor, place, messages))
                        .toList();
        List<String> said = new ArrayList<>();
        for (Letter slice : slices) {
            slots.forEach(slot -> slot.write(slice));
            boolean kept = (Boolean) call(monitor, "slice");
            String violation = ((String) call(monitor, "violation")).strip();
            assertThat(kept).isEqualTo(violation.isEmpty());
            said.add(violation);
            if (!kept) {
                break;
            }
        }
        return said;
    }

    private static Object call(Object object, String method) {
        try {
            return object.getClass().getMethod(method).invoke(object);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
