package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;

/** What leJOS' own classes and methods cost a program, by the resource {@code library.txt}. */
final class LibraryCost {
    private static final String RESOURCE = "/brick/library.txt";
    private static final String DEFAULT = "default";

    /** Bytes of what a class keeps for itself, once it is used. */
    private final Map<String, Long> classes = new HashMap<>();

    private final Map<String, Long> objects = new HashMap<>();
    private final Map<String, Long> calls = new HashMap<>();
    private final Map<String, Long> idle = new HashMap<>();
    private final Set<String> waits = new HashSet<>();
    private final Map<String, String> loops = new HashMap<>();
    private final Set<String> apart = new HashSet<>();
    private final Set<String> ends = new HashSet<>();
    private final Set<String> ofObjects = new HashSet<>();

    private LibraryCost() {}

    static LibraryCost read() {
        try (InputStream in = LibraryCost.class.getResourceAsStream(RESOURCE)) {
            LibraryCost library = new LibraryCost();
            new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.isBlank() && !line.startsWith("#"))
                    .forEach(line -> library.add(line.split(" ")));
            return library;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void add(String[] words) {
        switch (words[0]) {
            case "class" -> classes.put(words[1], Long.parseLong(words[2]));
            case "new" -> objects.put(words[1], Long.parseLong(words[2]));
            case "call" -> calls.put(words[1], Long.parseLong(words[2]));
            case "idle" -> idle.put(words[1], Long.parseLong(words[2]));
            case "waits" -> waits.add(words[1]);
            case "loops" -> loops.put(words[1], words[2]);
            case "ends" -> ends.add(words[1]);
            case "objects" -> ofObjects.add(words[1]);
            case "apart" -> {
                apart.add(words[1]);
                calls.put(words[1], Long.parseLong(words[2]));
            }
            case DEFAULT ->
                    (words[1].equals("new") ? objects : calls)
                            .put(DEFAULT, Long.parseLong(words[2]));
            default -> throw new IllegalStateException(String.join(" ", words));
        }
    }

    /** What a class that is used keeps in memory, its objects left out. */
    long bytesOf(String type) {
        return classes.getOrDefault(type, 0L);
    }

    long bytesOfObject(String type) {
        return Objects.requireNonNull(objects.getOrDefault(type, objects.get(DEFAULT)));
    }

    /**
     * How often a loop of the runtime goes round at most, where its code does not show it: a
     * number, or one of the words for sizes.
     */
    Optional<String> rounds(MethodName method) {
        return find(loops, method);
    }

    /** Whether a method of the runtime is counted apart: it does something only now and then. */
    boolean isApart(MethodName method) {
        return apart.contains(method.owner() + "." + method.name());
    }

    /** Whether a method of the runtime is counted apart with all ways that lead to it. */
    boolean isEnd(MethodName method) {
        return ends.contains(method.owner() + "." + method.name());
    }

    /** Whether monitors call a method of the runtime only for texts and objects. */
    boolean isOfObjects(MethodName method) {
        return ofObjects.contains(method.owner() + "." + method.name() + method.descriptor());
    }

    /** What is known of a method besides its code: microseconds. */
    OptionalLong measured(MethodName method) {
        return number(find(calls, method));
    }

    /** For how much of that time a method leaves the processor to others, in microseconds. */
    long idle(MethodName method) {
        return number(find(idle, method)).orElse(0);
    }

    /** How long a method of leJOS takes, in microseconds. */
    long time(MethodName method) {
        OptionalLong measured = measured(method);
        if (measured.isPresent()) {
            return measured.getAsLong();
        }
        if (mayWait(method)) {
            throw Unknown.of(method, "may wait");
        }
        return Objects.requireNonNull(calls.get(DEFAULT));
    }

    private boolean mayWait(MethodName method) {
        String name = method.owner() + "." + method.name();
        return waits.contains(name + method.descriptor())
                || waits.contains(name)
                || waits.contains(method.owner() + ".*")
                || isBelow(method.owner());
    }

    private boolean isBelow(String type) {
        int slash = type.lastIndexOf('/');
        while (slash > 0) {
            if (waits.contains(type.substring(0, slash) + "/*")) {
                return true;
            }
            slash = type.lastIndexOf('/', slash - 1);
        }
        return false;
    }

    private static <V> Optional<V> find(Map<String, V> values, MethodName method) {
        String name = method.owner() + "." + method.name();
        V precise = values.get(name + method.descriptor());
        return Optional.ofNullable(precise != null ? precise : values.get(name));
    }

    private static OptionalLong number(Optional<Long> value) {
        return value.map(OptionalLong::of).orElse(OptionalLong.empty());
    }
}
