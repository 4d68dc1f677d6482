package arcomat.benchmarks.measure;

import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Models from texts that have no errors. */
public final class LoweredSources {
    private LoweredSources() {}

    /**
     * The model of some components.
     *
     * @param folder of the files, one for each text
     */
    public static Model of(String folder, List<String> texts) {
        List<SourceFile> sources = new ArrayList<>();
        for (String text : texts) {
            sources.add(new SourceFile(folder + "/" + sources.size() + ".arc", text));
        }
        return of(sources);
    }

    public static Model of(List<SourceFile> sources) {
        return Lowering.lower(
                Workspace.of(
                        sources.stream()
                                .map(file -> Parser.parse(file).unit().orElseThrow())
                                .toList(),
                        Set.of(),
                        HouseLanguages.reader()));
    }
}
