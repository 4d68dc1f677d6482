package arcomat.lower;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Span;
import arcomat.symbols.Scenario;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Nothing is left out of a model, not even the places in the text that errors point to. */
class WholeModelTest {
    static List<Path> scenarios() {
        return Scenario.in("lower");
    }

    @ParameterizedTest
    @MethodSource("scenarios")
    void everythingIsThere(Path file) throws ReflectiveOperationException {
        requireAll(Lowering.lower(Scenario.read(file).workspace()), "model");
    }

    private static void requireAll(Object value, String where) throws ReflectiveOperationException {
        assertThat(value).as(where).isNotNull();
        if (value instanceof Collection<?> many) {
            for (Object each : many) {
                requireAll(each, where);
            }
        } else if (value instanceof Map<?, ?> map) {
            requireAll(map.values(), where);
        } else if (value instanceof Optional<?> perhaps) {
            requireAll(perhaps.map(Set::of).orElse(Set.of()), where);
        } else if (value instanceof Record && !(value instanceof Span)) {
            for (RecordComponent each : value.getClass().getRecordComponents()) {
                String place = value.getClass().getSimpleName() + "." + each.getName();
                requireAll(each.getAccessor().invoke(value), place);
            }
        }
    }
}
