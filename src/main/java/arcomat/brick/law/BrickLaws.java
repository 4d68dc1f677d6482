package arcomat.brick.law;

import java.util.List;

/** The list of all laws about programs for the brick. */
public final class BrickLaws {
    /** One line per law, in alphabetical order. */
    public static final List<BrickLaw> ALL =
            List.of(
                    new ClassEstimate(),
                    new ClassLimit(),
                    new ConstantLimit(),
                    new DisplayLetters(),
                    new FieldLimit(),
                    new KnownDefects(),
                    new LocalLimit(),
                    new MembersOnTheBrick(),
                    new MemoryLimit(),
                    new MethodLimit(),
                    new NoInterfaceBodies(),
                    new NoInvokeDynamic(),
                    new OwnPackages(),
                    new ParameterLimit(),
                    new ReadableClassFiles(),
                    new SliceLimit(),
                    new StaticFieldLimit());

    private BrickLaws() {}
}
