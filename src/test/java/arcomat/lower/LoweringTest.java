package arcomat.lower;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.symbols.Scenario;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Name;
import arcomat.tree.Unit;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Every file in the folder is a set of models with the model that they mean. */
class LoweringTest {
    @TestFactory
    List<DynamicTest> modelsMeanWhatIsWrittenBehindThem() {
        return Scenario.in("lower").stream()
                .map(
                        file ->
                                DynamicTest.dynamicTest(
                                        file.getFileName().toString(),
                                        file.toUri(),
                                        () -> {
                                            Scenario scenario = Scenario.read(file);
                                            assertThat(
                                                            ModelText.of(
                                                                    Lowering.lower(
                                                                            scenario.workspace())))
                                                    .isEqualTo(scenario.expected());
                                        }))
                .toList();
    }

    /** Texts have no word for it; languages of guests say it beside. */
    @Test
    void statesKeepWhatTheyStandIn() {
        Unit unit =
                Parser.parse(
                                new SourceFile(
                                        "Lift.ioautomaton",
                                        "automaton Lift { state up, down; initial up; }"))
                        .unit()
                        .orElseThrow();
        List<AutomatonElement> elements =
                ((Automaton) unit.definition())
                        .elements().stream().map(LoweringTest::inShaft).toList();
        Automaton nested = new Automaton(unit.span(), List.of(), Optional.empty(), elements);
        Unit changed =
                new Unit(unit.span(), Optional.empty(), List.of(), nested, List.of(), List.of());
        Workspace workspace = Workspace.of(List.of(changed), Set.of(), HouseLanguages.reader());
        assertThat(Lowering.lower(workspace).components().get(0).automata().get(0).within())
                .containsExactly(List.of("shaft", "up"), List.of("shaft", "down"));
    }

    private static AutomatonElement inShaft(AutomatonElement element) {
        if (!(element instanceof AutomatonElement.States states)) {
            return element;
        }
        Name shaft = new Name(states.span(), "shaft");
        return new AutomatonElement.States(
                states.span(),
                states.states().stream()
                        .map(each -> each.within(List.of(shaft, each.name())))
                        .toList());
    }
}
