package arcomat.pipeline.check;

import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.FeatureChoice;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * One configuration of a component that a command names without choosing all of its features, or
 * the component itself where nothing is left to choose.
 *
 * @param written as for {@link MainComponent#find}, with all features chosen
 */
public record ChosenComponent(String written, FeatureChoice choice) {
    /** Each configuration that agrees with what is chosen, in their order; one at least. */
    public static List<ChosenComponent> of(String written, Workspace models) {
        List<ChosenComponent> all =
                WrittenComponent.parse(written, models).stream()
                        .flatMap(
                                each ->
                                        each.symbols(models).stream()
                                                .map(s -> configurations(each, s, models)))
                        .flatMap(List::stream)
                        .toList();
        return all.isEmpty() ? List.of(new ChosenComponent(written, FeatureChoice.NONE)) : all;
    }

    private static List<ChosenComponent> configurations(
            WrittenComponent named, ComponentSymbol symbol, Workspace models) {
        return models.configurations(symbol).stream()
                .filter(each -> !each.declaration().configuration().choices().isEmpty())
                .filter(each -> each.qualifiedName().endsWith(")"))
                .flatMap(each -> chosen(named, each))
                .toList();
    }

    private static Stream<ChosenComponent> chosen(
            WrittenComponent named, ComponentSymbol configuration) {
        FeatureChoice choice = configuration.declaration().configuration();
        List<String> rest = new ArrayList<>();
        for (String argument : named.arguments()) {
            String[] sides = argument.split("=", 2);
            Boolean chosen = choice.choices().get(sides[0].strip());
            if (chosen == null) {
                rest.add(argument);
            } else if (!sides[sides.length - 1].strip().equals(chosen.toString())) {
                return Stream.empty();
            }
        }
        choice.choices().forEach((feature, value) -> rest.add(feature + " = " + value));
        String qualified = configuration.qualifiedName();
        String name = qualified.substring(0, qualified.indexOf('('));
        return Stream.of(new ChosenComponent(name + "(" + String.join(", ", rest) + ")", choice));
    }

    /** Whether features of one name are chosen alike. */
    public boolean agrees(ChosenComponent other) {
        return choice.choices().entrySet().stream().allMatch(each -> isSame(each, other));
    }

    private static boolean isSame(Map.Entry<String, Boolean> chosen, ChosenComponent other) {
        return other.choice
                .choices()
                .getOrDefault(chosen.getKey(), chosen.getValue())
                .equals(chosen.getValue());
    }
}
