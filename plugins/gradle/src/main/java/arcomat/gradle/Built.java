package arcomat.gradle;

import org.gradle.api.file.Directory;
import org.gradle.api.file.FileTreeElement;
import org.gradle.api.provider.Provider;
import org.gradle.api.specs.Spec;

/** Whether something lies where builds put what they make. */
final class Built implements Spec<FileTreeElement> {
    private final Provider<Directory> buildDirectory;

    Built(Provider<Directory> buildDirectory) {
        this.buildDirectory = buildDirectory;
    }

    @Override
    public boolean isSatisfiedBy(FileTreeElement element) {
        return element.getFile().equals(buildDirectory.get().getAsFile());
    }
}
