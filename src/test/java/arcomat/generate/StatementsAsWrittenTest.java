package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Generated code has as many lines as the statements that it is written of, for each target. */
class StatementsAsWrittenTest {
    private static final String CHOICE = "    if (d > %d) {\n      total += %d;\n    }";

    @ParameterizedTest
    @ValueSource(strings = {"jvm", "lejos"})
    void eachChoiceHasThreeLines(String target) {
        assertThat(lines(target, "<<total>> ", 40) - lines(target, "<<total>> ", 20))
                .isEqualTo(3 * 20);
        assertThat(lines(target, "", 40) - lines(target, "", 20)).isEqualTo(3 * 20);
    }

    private static long lines(String target, String stereotype, int choices) {
        String text =
                """
                component Many {
                  port %sin Integer d, out Integer sum;
                  var Integer total = 0;
                  <<completion = "ignore">> compute {
                %s
                    sum = total;
                  }
                }
                """
                        .formatted(
                                stereotype,
                                IntStream.range(0, choices)
                                        .mapToObj(i -> CHOICE.formatted(7 * i, i))
                                        .collect(Collectors.joining("\n")));
        Generation generation =
                Generator.generate(
                        Request.all(model(text), Choosing.FIRST),
                        Target.shipped(target).orElseThrow());
        assertThat(generation.findings()).noneMatch(Diagnostic::isError);
        return generation.files().stream().mapToLong(file -> file.text().lines().count()).sum();
    }

    private static Model model(String text) {
        Workspace workspace =
                Workspace.of(
                        List.of(
                                Parser.parse(new SourceFile("Many.arc", text))
                                        .unit()
                                        .orElseThrow()),
                        Set.of(),
                        HouseLanguages.reader());
        assertThat(Checks.run(workspace, Profile.EXECUTABLE)).noneMatch(Diagnostic::isError);
        return Lowering.lower(workspace);
    }
}
