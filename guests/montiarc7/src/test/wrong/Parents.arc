component Parents extends Call, Loop { }
