package arcomat.laws;

import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.naive.TableRows;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.source.SourceFile;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * Of a table the first row that fits decides, and no other: for each input, the row that its text
 * says is the only one that may be taken.
 */
final class FirstRowDecides implements Law {
    @Override
    public String name() {
        return "12 the first row decides";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return List.of(ComponentText.types(), ComponentText.table(draw, "a", "Main"));
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        StepRelation relation = ComponentSemantics.of(component, List.of()).relations().get(0);
        TableRows rows = TableRows.of(component.span().file().text());
        boolean met = false;
        for (@Nullable Value[] letter : letters(component.inputs())) {
            List<Integer> fit = rows.deciding(texts(component.inputs(), letter)).stream().toList();
            List<Integer> may =
                    relation
                            .choices(
                                    relation.starts().get(0).configuration(),
                                    Input.of(letter.clone()))
                            .enabled()
                            .stream()
                            .map(Trace.Taken::index)
                            .toList();
            if (!may.equals(fit)) {
                return Outcome.broken(
                        "rows "
                                + may
                                + " may be taken, but "
                                + fit
                                + " decides on "
                                + Arrays.toString(letter),
                        "simulate --main " + Pairs.LEFT);
            }
            met |= !fit.isEmpty();
        }
        return met ? Outcome.KEPT : Outcome.SKIPPED;
    }

    /** All of them: a message of each input, or none. */
    private static List<@Nullable Value[]> letters(List<Port> inputs) {
        List<@Nullable Value[]> letters = new ArrayList<>();
        letters.add(new Value[inputs.size()]);
        for (int i = 0; i < inputs.size(); i++) {
            List<@Nullable Value[]> longer = new ArrayList<>();
            for (@Nullable Value[] each : letters) {
                if (!inputs.get(i).total()) {
                    longer.add(each);
                }
                for (Value message : values(inputs.get(i).type())) {
                    @Nullable Value[] with = each.clone();
                    with[i] = message;
                    longer.add(with);
                }
            }
            letters = longer;
        }
        return letters;
    }

    private static List<Value> values(Type type) {
        if (type instanceof Type.EnumType choice) {
            return IntStream.range(0, choice.constants().size())
                    .<Value>mapToObj(i -> new Value.EnumValue(choice, i))
                    .toList();
        }
        return type instanceof Type.IntegerType range
                ? LongStream.rangeClosed(range.low(), range.high())
                        .<Value>mapToObj(Value.IntegerValue::new)
                        .toList()
                : Stream.of(true, false).<Value>map(Value.BooleanValue::new).toList();
    }

    private static Map<String, String> texts(List<Port> inputs, @Nullable Value[] letter) {
        Map<String, String> texts = new LinkedHashMap<>();
        for (int i = 0; i < letter.length; i++) {
            if (letter[i] != null) {
                texts.put(inputs.get(i).name(), letter[i].toString());
            }
        }
        return texts;
    }
}
