package arcomat.models;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Layer;
import arcomat.syntax.Formatter;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.List;

/** The model library is flawless, documented, and fits its layers. */
class LibraryModelsTest {
    private static final List<SourceFile> FILES = ModelFiles.under(ModelFiles.LIBRARY);
    private static final Workspace WORKSPACE = ReadModels.workspace(FILES);

    @ParameterizedTest
    @EnumSource
    void nothingIsFoundFault(Profile profile) {
        assertThat(Checks.run(WORKSPACE, profile)).isEmpty();
    }

    @Test
    void everyFileIsFormatted() {
        for (SourceFile file : FILES) {
            assertThat(Formatter.format(file).text()).contains(file.text());
        }
    }

    @Test
    void sensorsSendAndActuatorsReceive() {
        assertThat(WORKSPACE.components()).isNotEmpty();
        for (ComponentSymbol component : WORKSPACE.components()) {
            assertThat(component.isPlatform()).as(component.name()).isTrue();
            assertThat(component.ports())
                    .as(component.name())
                    .isNotEmpty()
                    .allMatch(
                            port ->
                                    port.isInput()
                                            == (component.signature().layer() == Layer.ACTUATORS));
        }
    }

    /** A doc comment above the component, and words on every parameter that is no socket. */
    @Test
    void everyComponentIsDocumented() {
        for (SourceFile file : FILES) {
            assertThat(file.text()).as(file.path()).containsPattern("\n/\\*\\*(?s:.*)\\*/\n");
        }
        for (ComponentSymbol component : WORKSPACE.components()) {
            String text = component.unit().file().text();
            String comment = text.substring(0, text.indexOf("*/"));
            component.parameters().stream()
                    .filter(parameter -> !isPlace(parameter.type().text()))
                    .forEach(parameter -> assertThat(comment).contains(parameter.name()));
        }
    }

    private static boolean isPlace(String type) {
        return type.contains("Port") || type.contains("Key");
    }
}
