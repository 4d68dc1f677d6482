package arcomat.brick.need;

import org.objectweb.asm.tree.analysis.BasicValue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * What objects of a program hold.
 *
 * @param objects their classes
 * @param fields those whose value is known
 */
record Store(List<String> objects, Map<Field, KnownValue> fields) {
    /**
     * A field of an object.
     *
     * @param object its number
     * @param name with the class that declares it
     */
    record Field(int object, String name) {}

    /** No object is there. */
    static final Store EMPTY = new Store(List.of(), Map.of());

    int size() {
        return objects.size() + fields.size();
    }

    /** A further object, which has the last number. */
    Store made(String type, Map<String, KnownValue> values) {
        List<String> more = new ArrayList<>(objects);
        more.add(type);
        Map<Field, KnownValue> all = new HashMap<>(fields);
        values.forEach((name, value) -> all.put(new Field(objects.size(), name), value));
        return new Store(more, all);
    }

    Store with(Field field, BasicValue value) {
        if (value.equals(fields.get(field))) {
            return this;
        }
        Map<Field, KnownValue> others = new HashMap<>(fields);
        if (value instanceof KnownValue known) {
            others.put(field, known);
        } else {
            others.remove(field);
        }
        return new Store(objects, others);
    }

    /** Without what some fields hold, in all objects. */
    Store without(Set<String> names) {
        return fields.keySet().stream().noneMatch(field -> names.contains(field.name()))
                ? this
                : only(each -> !names.contains(each.getKey().name()));
    }

    /** Which object knows which, and no numbers. */
    Store ofObjects() {
        return only(each -> each.getValue().isObject());
    }

    private Store only(Predicate<Map.Entry<Field, KnownValue>> kept) {
        return new Store(
                objects,
                fields.entrySet().stream()
                        .filter(kept)
                        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue)));
    }
}
