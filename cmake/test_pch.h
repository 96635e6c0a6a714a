// Precompiled for every test program.
#pragma once
#include "cmake/core_pch.h"
#include <QtCore/QtCore>
