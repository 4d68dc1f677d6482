package arcomat.pipeline;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.StubWriter;

import java.util.Optional;

/**
 * The brick's classes and nothing else: code that compiles against them uses only what is there.
 * Stubs are written when the compiler asks for them, which is for a few of the six hundred.
 */
final class BrickClasses implements ClassSource {
    private final BrickTable table;
    private final StubWriter stubs;

    BrickClasses(BrickTable table) {
        this.table = table;
        this.stubs = new StubWriter(table);
    }

    @Override
    public Optional<byte[]> classFile(String name) {
        return table.type(name).map(stubs::write);
    }

    @Override
    public boolean isPackage(String name) {
        return table.isPackage(name);
    }
}
