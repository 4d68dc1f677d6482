package arcomat.editor.answer.completion;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.CampaignParser;
import arcomat.pipeline.brick.ScriptText;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.WorldParser;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/** What is offered to be filled in is right before anybody has filled in anything. */
class LineSkeletonTest {
    private static final Pattern PLACE = Pattern.compile("\\$\\{\\d+:([^}]*)}|\\$\\d");

    /** What stands around a line, by the word that it begins with. */
    private static final Map<String, String> AROUND =
            Map.of(
                    "kind", "floor 900 900\n%s\nrobot one rover at 300 500\n",
                    "robot", "floor 900 900\nkind rover\n  program jar a.jar\n%s\n",
                    "vary", "world a.world\nsample random 1\n%s\n",
                    "require", "world a.world\nsample random 1\n%s\n");

    static List<LineSkeleton> all() {
        return LineSkeleton.ALL;
    }

    @ParameterizedTest
    @MethodSource("all")
    void hasNoFindings(LineSkeleton each) {
        String filled = PLACE.matcher(each.skeleton().text()).replaceAll("$1");
        String whole = AROUND.getOrDefault(each.skeleton().word(), "%s").formatted(filled);
        assertThat(findings(new SourceFile("a" + each.ending(), whole))).as(whole).isEmpty();
    }

    private static List<Diagnostic> findings(SourceFile file) {
        return switch (file.path()) {
            case "a.world" -> WorldParser.parse(file).findings();
            case "a.campaign" -> CampaignParser.parse(file).findings();
            default -> ScriptText.read(file).findings();
        };
    }
}
