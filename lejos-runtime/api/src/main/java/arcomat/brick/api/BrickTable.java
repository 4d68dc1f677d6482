package arcomat.brick.api;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** All classes of the brick, in the order of the table they are read from. */
public final class BrickTable {
    private static final String RESOURCE = "lejos-nxj-0.9.1.tsv";

    private final Map<String, BrickType> types;
    private final Set<String> packages;
    private final Map<String, List<BrickType>> nested;

    BrickTable(List<BrickType> types) {
        Map<String, BrickType> byName = new LinkedHashMap<>();
        types.forEach(type -> byName.put(type.name(), type));
        this.types = Collections.unmodifiableMap(byName);
        this.packages =
                types.stream().map(BrickType::packageName).collect(Collectors.toUnmodifiableSet());
        this.nested =
                types.stream()
                        .filter(type -> type.nesting().isPresent())
                        .collect(Collectors.groupingBy(type -> type.nesting().get().outer()));
    }

    /** The table of leJOS NXJ 0.9.1 that comes with the product. Reads it anew; keep the result. */
    public static BrickTable leJos() {
        try (InputStream in = BrickTable.class.getResourceAsStream(RESOURCE)) {
            return TableReader.read(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public Collection<BrickType> types() {
        return types.values();
    }

    /**
     * @param name internal name, as {@code java/util/Map$Entry}
     */
    public Optional<BrickType> type(String name) {
        return Optional.ofNullable(types.get(name));
    }

    public boolean contains(String name) {
        return types.containsKey(name);
    }

    /** Whether some class lies in this package (internal name) or in one below it. */
    public boolean isPackage(String name) {
        return packages.contains(name)
                || packages.stream().anyMatch(other -> other.startsWith(name + "/"));
    }

    /** The classes that are declared inside of a class. */
    public List<BrickType> nestedIn(String outer) {
        return Collections.unmodifiableList(nested.getOrDefault(outer, List.of()));
    }
}
