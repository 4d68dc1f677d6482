package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;

/** Dependencies that follow edits are those that are found out anew. */
class DependenciesTest {
    private static final int FILES = 30;
    private static final int ROUNDS = 40;

    @Tag("slow")
    @Property(tries = 4)
    void followEdits(@ForAll long seed) throws IOException {
        Path folder = Files.createTempDirectory("dependencies");
        try {
            EditedModels models = new EditedModels(folder, new Random(seed));
            while (models.size() < FILES) {
                models.add();
            }
            OpenModels open = OpenModels.in(folder, false);
            Dependencies kept = Dependencies.NONE;
            Collection<CheckState.File> before = List.of();
            String toldBefore = text(kept, before);
            for (int round = 0; round < ROUNDS; round++) {
                open = open.with(OpenModelsTest.edit(open, folder));
                Collection<CheckState.File> files = open.remembered().values();
                Dependencies now = kept.with(files);
                String told = text(now, files);
                assertThat(told).isEqualTo(text(Dependencies.of(files), files));
                assertThat(text(kept, before))
                        .as("those before, whom others may still ask")
                        .isEqualTo(toldBefore);
                kept = now;
                toldBefore = told;
                before = files;
                models.edit();
            }
        } finally {
            IncrementalCheckTest.delete(folder);
        }
    }

    /** All that they tell. */
    private static String text(Dependencies dependencies, Collection<CheckState.File> files) {
        StringBuilder text = new StringBuilder();
        text.append(new TreeSet<>(dependencies.named())).append('\n');
        for (CheckState.File file : files) {
            List<String> path = List.of(file.path());
            text.append(file.path())
                    .append(" needs ")
                    .append(new TreeSet<>(dependencies.neededBy(path)))
                    .append(", touches ")
                    .append(new TreeSet<>(dependencies.affectedBy(List.of(FileInterface.of(file)))))
                    .append(", goes with ")
                    .append(new TreeSet<>(dependencies.connectedWith(path)))
                    .append(dependencies.isMentioned(path, file.mentions()))
                    .append('\n');
        }
        return text.toString();
    }
}
